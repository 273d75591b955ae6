#!/usr/bin/env bash
# Builds the image of Containerfile from a finished package with buildah, and runs a case in it. Its base, debian:12-slim, is
# a bare Debian that mmdebstrap makes, so that no registry of images is asked. Compiling is the part of scripts/build.sh: the
# first stage stays out. As root; where there is no buildah it says so and ends with 0.
# usage: check_container.sh PACKAGE.deb FOLDER   FOLDER/debian is kept: another call begins with it
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/bare_debian.bash"
source_dir=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
package=$(realpath "$1")
folder=$(realpath -m "$2")
for needed in buildah mmdebstrap; do
    command -v $needed >/dev/null || { echo "skipped: there is no $needed (apt-get install $needed)"; exit 0; }
done
[ "$(id -u)" -eq 0 ] || { echo "skipped: a bare Debian needs root"; exit 0; }

mkdir -p "$folder/empty" "$folder/work"
bare_debian "$folder/debian"
tar -C "$folder/debian" --exclude='./var/cache/apt/archives/*.deb' -cf "$folder/base.tar" .
# Images and containers of its own, gone afterwards; no user namespaces, no overlays: it works within containers, too.
export STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot
buildah() { command buildah --root "$folder/images" --runroot "$folder/run" "$@"; }
trap 'buildah rm --all >/dev/null 2>&1; buildah rmi --all --force >/dev/null 2>&1; rm -rf "$folder"/{images,run,base.tar}' EXIT

# image FILE PLACE NAME
image() {
    local container
    container=$(buildah from scratch)
    buildah add -q "$container" "$1" "$2" >/dev/null
    buildah commit -q "$container" "$3" >/dev/null
    buildah rm "$container" >/dev/null
}
image "$folder/base.tar" / docker.io/library/debian:12-slim
image "$package" /tricontact/build/release/packages/ localhost/tricontact-packages
buildah build -q -t tricontact --pull-never --build-arg PACKAGES=localhost/tricontact-packages \
    -f "$source_dir/Containerfile" "$folder/empty" >"$folder/log" 2>&1 || { tail "$folder/log"; exit 1; }

# The case of README.
awk '/^```toml/ { on = 1; next } on && /^```/ { exit } on' "$source_dir/README.md" >"$folder/work/case.toml"
container=$(buildah from --pull-never tricontact)
buildah inspect --format '{{.OCIv1.Config.Entrypoint}}' "$container" | grep -qx '\[tricontact\]' || { echo "FAILED: entry point"; exit 1; }
buildah run -v "$folder/work:/work" "$container" -- tricontact --version
buildah run -v "$folder/work:/work" "$container" -- tricontact run case.toml --quiet
for file in report.html summary.json plots/shift.png; do
    [ -s "$folder/work/results/case/$file" ] || { echo "FAILED: the run in the container left no $file"; exit 1; }
done
echo "container: passed"
