# SPDX-License-Identifier: BSD-3-Clause
# Completion of fstiff in bash: commands, options and words are those that `fstiff help` lists.
_fstiff() {
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=
    [ "$COMP_CWORD" -gt 1 ] && command=${COMP_WORDS[1]}
    # these are commands of their own
    [[ "${COMP_WORDS[*]:1:COMP_CWORD-1} " =~ ^measure\ .*--show\ (=\ )?(fit|islands|peaks|spectrum)\  ]] &&
        command="measure --show ${BASH_REMATCH[2]}"
    # bash splits --format=json into three words
    if [ "$current" = '=' ]; then
        current=
    elif [ "$before" = '=' ] && [ "$COMP_CWORD" -gt 2 ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    COMPREPLY=($(compgen -W "$({
        "${COMP_WORDS[0]}" help $command 2>/dev/null
        [ "$command" != help ] || "${COMP_WORDS[0]}" help | sed -nE '/^(Compute|Surfaces|Measured K|Checks|Help):/,/^$/p'
    } | awk -v before="$before" -v current="$current" '
        # words of {one,two} in the help of an option or argument
        function words() { return match($0, /:[{][^}]*[}]/) ? substr($0, RSTART + 2, RLENGTH - 3) : "" }
        /^  -/ {
            count = split($1, names, ",")
            for (i = 1; i <= count; i++) {
                options = options " " names[i]
                if (names[i] == before && $2 ~ /^[A-Z]/) { value = 1; chosen = words() }
            }
        }
        /^Positionals:/ { arguments = 1 }
        /^(Compute|Surfaces|Measured K|Checks|Help):/ { commands = 1 }
        /^$/ { arguments = commands = 0 }
        arguments && words() { plain = words() }
        commands && /^  / { plain = plain "," $1 }
        END { answer = value ? chosen : current ~ /^-/ ? options : plain; gsub(",", " ", answer); print answer }
    ')" -- "$current"))
}
complete -o default -F _fstiff fstiff
