#compdef jaka
# Completes lines of jaka in zsh, by what jaka itself says.

_jaka() {
    local line
    local -a lines values
    # Without a quote that is still open, and up to the cursor.
    lines=("${(@f)$("${words[1]}" complete-words "--current=${(Q)PREFIX}" -- "${(@Q)words[2,CURRENT-1]}" 2>/dev/null)}")
    if [[ $lines[1] == file ]]; then
        # A path may follow the name of an option and an equals sign.
        [[ $PREFIX == --*=* ]] && compset -P '*='
        _files
        return
    fi
    for line in "${(@)lines[2,-1]}"; do
        values+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}")
    done
    _describe jaka values
}

if [[ $funcstack[1] == _jaka ]]; then
    _jaka "$@"
else
    compdef _jaka jaka
fi
