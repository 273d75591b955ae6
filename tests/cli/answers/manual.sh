#!/usr/bin/env bash
# The manual page and the completions of shells name each command and option of the program, and their readers
# take them.
# usage: manual.sh PROGRAM SOURCE_DIR
source "$(dirname -- "${BASH_SOURCE[0]}")/../prepare.bash"

"$program" manual man >tricontact.1
if command -v man >/dev/null; then
    man --warnings -l "$work/tricontact.1" >/dev/null 2>warnings || complain "man does not take the page"
    [ ! -s warnings ] || complain "man warns: $(cat warnings)"
fi
"$program" manual bash >completion.bash
bash -n completion.bash || complain "bash does not take its completion"
for shell in zsh fish; do
    "$program" manual "$shell" >"completion.$shell"
    ! command -v "$shell" >/dev/null || "$shell" -n "completion.$shell" || complain "$shell does not take its completion"
done

# What the help has, the others have: minus signs of the page are no hyphens.
sed 's/\\-/-/g' tricontact.1 >page
"$program" --help | sed -n '/^Compute:/,$s/^  \([a-z]\+\) .*/\1/p' >whole
cp whole commands
while read -r command; do
    "$program" "$command" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]\+ [a-z]\+\) .*/\1/p'
done <whole >>commands
[ "$(wc -l <commands)" -gt 22 ] || complain "only $(wc -l <commands) commands"
[ "$(grep -c '^.SH COMMANDS: ' page)" -eq 6 ] || complain "the page has not six groups"
while read -r command; do
    for file in page completion.bash completion.zsh completion.fish; do
        grep -qw -- "${command#* }" "$file" || complain "$file has no command $command"
    done
    # shellcheck disable=SC2086
    while read -r option; do
        grep -q -- "$option" page || complain "the page has no $option of $command"
        grep -q -- "$option" completion.bash || complain "completion.bash has no $option of $command"
        grep -q -- "$option" completion.zsh || complain "completion.zsh has no $option of $command"
        grep -qF -- "__fish_seen_subcommand_from ${command#* }' -l ${option#--}" completion.fish ||
            complain "completion.fish has no $option of $command"
    done < <("$program" $command --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | grep -v -- --help)
done <commands

# What bash offers at the end of a line.
offered() {
    (
        source completion.bash
        compopt() { :; }
        COMP_WORDS=("$@")
        COMP_CWORD=$(($# - 1))
        _tricontact
        printf '%s\n' "${COMPREPLY[@]}"
    )
}
is_offered() {
    local expected=$1
    shift
    offered "$@" | grep -xF -- "$expected" >/dev/null || complain "$* <TAB> does not offer $expected"
}
is_offered limit tricontact li
is_offered limit tricontact help li
is_offered -o tricontact limit case.toml -o
is_offered contact tricontact con
is_offered merge tricontact sweep me
is_offered export tricontact contact ""
is_offered show tricontact benchmark sh
is_offered --models tricontact contact export case.toml --mo
is_offered --distributed tricontact cache condense case.toml --di
is_offered --tolerance tricontact limit --to
is_offered amplitude tricontact limit case.toml --vary a
is_offered rolling.amplitude_ratio= tricontact run case.toml --set rolling.amp
is_offered mdr,bem tricontact run case.toml --models mdr,be
touch case.toml
is_offered case.toml tricontact check ca

finish
