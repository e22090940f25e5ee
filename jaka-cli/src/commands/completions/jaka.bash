# Completes lines of jaka in bash, by what jaka itself says.

_jaka() {
    local word at kind value help prefix is_open=
    local -a words=()
    # For bash, `=` and `:` are words of their own.
    for ((at = 1; at <= COMP_CWORD; at++)); do
        word=${COMP_WORDS[at]//[\\\"\']/}
        if ((${#words[@]})) && [[ $is_open || $word == [=:]* ]]; then
            words[${#words[@]}-1]+=$word
        else
            words+=("$word")
        fi
        [[ $word == *[=:] ]] && is_open=yes || is_open=
    done
    word=${words[${#words[@]}-1]}
    unset "words[${#words[@]}-1]"
    # What bash puts in the place of the word begins after the last of them.
    prefix=${word%"${word##*[=:]}"}
    COMPREPLY=()
    {
        read -r kind
        while IFS=$'\t' read -r value help; do
            COMPREPLY+=("$(printf %q "${value#"$prefix"}")")
        done
    } < <("$1" complete-words "--current=$word" -- "${words[@]}" 2>/dev/null)
    if [[ $kind == file ]]; then
        while IFS= read -r value; do
            COMPREPLY+=("$value")
        done < <(compgen -f -- "${word#"$prefix"}")
        compopt -o filenames 2>/dev/null
    fi
}
complete -F _jaka jaka
