# Completes lines of jaka in PowerShell, by what jaka itself says.

Register-ArgumentCompleter -Native -CommandName jaka -ScriptBlock {
    param($current, $line, $cursor)
    $words = @($line.CommandElements | Where-Object { $_.Extent.EndOffset -lt $cursor } | ForEach-Object { "$_" })
    $before = @($words | Select-Object -Skip 1)
    $lines = @(& $words[0] complete-words "--current=$current" -- $before 2>$null)
    # Nothing at all: PowerShell completes files.
    $lines | Select-Object -Skip 1 | ForEach-Object {
        $word, $help = $_ -split "`t", 2
        if (-not $help) { $help = $word }
        [System.Management.Automation.CompletionResult]::new($word, $word, 'ParameterValue', $help)
    }
}
