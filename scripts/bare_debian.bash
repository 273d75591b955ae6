# Sourced: a bare Debian 12 in a folder, and commands in it. As root.

# bare_debian BASE: made by mmdebstrap from this machine's mirror, unless it is there; its log beside it.
bare_debian() {
    local base=$1 sources mirror kind thrifty
    [ ! -e "$base/etc/debian_version" ] || return 0
    # The mirror of this machine, and its key.
    sources=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null || true)
    mirror=$(grep -oE '[a-z]+://[^ ]+/debian/?( |$)' <<<"$sources" | grep -v security | head -n 1 | tr -d ' ')
    rm -rf "$base"
    # The folder is thrown away: nothing is pressed to disk before the end, and what nobody looks at is not unpacked.
    thrifty=(--dpkgopt=force-unsafe-io)
    for kind in doc man locale; do
        thrifty+=("--dpkgopt=path-exclude=/usr/share/$kind/*" "--dpkgopt=path-include=/usr/share/$kind/*tricontact*")
    done
    # Half the time of debootstrap.
    mmdebstrap --mode=root --variant=minbase "${thrifty[@]}" bookworm "$base" "$mirror" >"$base.log" 2>&1 || {
        tail "$base.log"
        return 1
    }
}

# bare_copy BASE ROOT: a copy to install into; archives of packages that the machine has are not fetched again.
bare_copy() {
    rm -rf "$2"
    cp -a "$1" "$2"
    ln -f /var/cache/apt/archives/*.deb "$2/var/cache/apt/archives/" 2>/dev/null ||
        cp /var/cache/apt/archives/*.deb "$2/var/cache/apt/archives/" 2>/dev/null || true
}

# inside ROOT COMMAND...: in a space of mounts of its own: /proc goes away with it.
inside() {
    unshare --mount bash -c 'mount -t proc proc "$0/proc" && exec chroot "$0" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        HOME=/root DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"' "$@"
}
