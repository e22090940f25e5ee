# Completes lines of jaka in fish, by what jaka itself says.

function __jaka_complete
    set -l before (commandline -opc)
    set -l current (commandline -ct)
    set -l lines ($before[1] complete-words "--current=$current" -- $before[2..] 2>/dev/null)
    if test "$lines[1]" = file
        # A path may follow the name of an option and an equals sign.
        set -l name (string match -r -- '^--[^=]*=' "$current")
        set -l begun (string replace -- "$name" '' "$current")
        string replace -r -- '^' "$name" (__fish_complete_path "$begun")
    else
        printf '%s\n' $lines | tail -n +2
    end
end

complete -c jaka -f -a '(__jaka_complete)'
