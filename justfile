# Commands of the project, by `just` (https://just.systems) or by hand: each is one line. None of them is needed by
# `.ci/run`.

# Lists the commands.
default:
    @just --list --unsorted

# What every change must pass, in some 12 minutes.
check:
    .ci/run

# Writes all that is made from the spec and the pages, and checks the spec.
regenerate:
    .ci/regenerate

# What takes too long for each change; parts of it by their names.
nightly *parts:
    .ci/nightly {{parts}}

# Finds tests that depend on the machine: runs programs again and again in a hostile environment.
hostile *arguments:
    tests/hostile {{arguments}}

# Puts 80 defects into the code, one at a time, and lists those that no test notices.
mutants *arguments:
    tests/mutation-sample {{arguments}}

# Times beside serde and bare sockets: codec, framing, round_trip, pipelining, stop_latency, guard_reaction, pacing.
bench name:
    cargo bench --manifest-path benches/Cargo.toml --bench {{name}}

# Hostile input by libFuzzer, each target for so many minutes.
fuzz minutes="60" *targets:
    fuzz/campaign {{minutes}} {{targets}}

# Witnesses of others: Ruckig's and TOPP-RA's motions. Takes Python and PyPI.
outside:
    tests/outside/run

# A release from the tag to the files, with an upload that is none.
release *targets:
    release/rehearsal {{targets}}

# Pictures of the READMEs.
pictures:
    UPDATE_EXPECT=1 cargo test -p jaka-cli --bin jaka picture
    cargo run --manifest-path benches/Cargo.toml --bin stream_picture -- docs/streams.svg
