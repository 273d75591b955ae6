# Sourced after prepare.bash by tests of documents whose blocks work.

# run_blocks DOCUMENT: in the working folder, in their order, a block with `file=NAME` becomes that file,
# a block of `sh` is run and has to end with 0 or the code behind `exit=`. Counts them as $blocks; what
# the k-th wrote is in k.out.
run_blocks() {
    # To 1.block, 2.block, ...: the line of the fence, then the text.
    awk '/^```[a-z]/ { n++; file = n ".block" }
        /^```$/ { file = "" }
        file { print > file }' "$source_dir/docs/$1"
    mkdir bin
    ln -s "$program" bin/tricontact
    PATH=$PWD/bin:$PATH
    local fence due code
    blocks=0
    while [ -e $((blocks + 1)).block ]; do
        blocks=$((blocks + 1))
        fence=$(head -1 $blocks.block)
        sed -i 1d $blocks.block
        case $fence in
            *' file='*) cp $blocks.block "${fence##* file=}" ;;
            '```sh'*)
                due=0
                [[ $fence == *' exit='* ]] && due=${fence##* exit=}
                bash -eu $blocks.block >$blocks.out 2>&1
                code=$?
                [ "$code" -eq "$due" ] ||
                    complain "exit code $code of: $(cat $blocks.block): $(tail -3 $blocks.out)"
                ;;
            *) complain "what is a block $fence?" ;;
        esac
    done
}
