# Commands of the project. `just` (https://just.systems) runs them by name; by hand, each is the line below its name.
# `.ci/run` needs none of them.

# Lists the commands.
default:
    @just --list --unsorted

# What every change must pass: format, lints, tests, docs, oldest compilers, in some 12 minutes.
check:
    .ci/run

# Writes all that is made from the spec and the pages, and checks the spec.
regenerate:
    .ci/regenerate

# Everything else: other builds, what is compiled, each example, long forms of tests. Parts of it by their names.
nightly *parts:
    .ci/nightly {{parts}}

# Runs test programs again and again in an environment that holds their threads up.
hostile *arguments:
    tests/hostile {{arguments}}

# Puts 80 defects into the code, one at a time, and lists those that no test notices: docs/mutation-testing.md.
mutants *arguments:
    tests/mutation-sample {{arguments}}

# Times beside serde and bare sockets: codec, round_trip, stop_latency, guard_reaction, planning.
bench name *arguments:
    cargo bench --manifest-path benches/Cargo.toml --bench {{name}} -- {{arguments}}

# Instructions beside the stored counts, which `--write` renews: docs/performance.md.
instructions *arguments:
    .ci/instructions {{arguments}}

# Times of builds.
build-time:
    benches/build-time

# Random schedules of the threads that share a connection, a monitor or the state of an arm: docs/reliability.md.
interleavings:
    .ci/interleavings

# Hostile input by libFuzzer, each target for so many minutes: docs/fuzzing.md.
fuzz minutes="60" *targets:
    fuzz/campaign {{minutes}} {{targets}}

# Witnesses of others: motions of Ruckig and TOPP-RA. Takes Python and PyPI.
outside:
    tests/outside/run

# The recipe for a new command, in a copy.
new-command:
    tests/new-command

# The JSON Schema by the standard. Takes PyPI.
json-schema:
    tests/json-schema

# The libraries' interface beside that of the last release, by cargo-semver-checks: docs/compatibility.md.
interface *arguments:
    .ci/semver {{arguments}}

# What is compiled: docs/supply-chain.md.
supply:
    .ci/deny
    .ci/tree
    .ci/msrv
    .ci/platforms
    .ci/package

# Workflows and scripts, by actionlint and shellcheck.
forge:
    .ci/forge

# Moving pictures of the READMEs.
pictures:
    UPDATE_EXPECT=1 cargo test -p jaka-cli --bin jaka picture
    cargo run --manifest-path benches/Cargo.toml --bin stream_picture -- docs/streams.svg

# A release from the tag to the files, with an upload that is none: docs/install.md.
release *targets:
    release/rehearsal {{targets}}
