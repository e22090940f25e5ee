#!/usr/bin/env python3
"""Prints the licences of all code of others in the program `jaka` for a target, with their texts.

    release/third_party.py x86_64-unknown-linux-musl >THIRD-PARTY-LICENSES

The crates are those that cargo compiles for the program, build scripts and macros included. Fails where a crate has
neither the text of a licence nor a licence expression.
"""

import html
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# C libraries that the toolchain links into the program, by the end of the target's name.
RUNTIMES = {
    "-musl": ("musl, the C library", ROOT / "release/notices/musl.txt"),
    "-windows-gnu": ("mingw-w64, the C runtime", pathlib.Path("/usr/share/doc/mingw-w64-x86-64-dev/copyright")),
}
FILE_NAME = re.compile(r"(licen[cs]e|unlicense|copying|copyright|notice)", re.IGNORECASE)


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, encoding="utf-8", cwd=ROOT).stdout


def crates(target):
    """Packages of other projects in the program's tree, as `cargo metadata` describes them."""
    tree = output("cargo", "tree", "--locked", "-p", "jaka-cli", "-e", "normal,build", "--target", target,
                  "--prefix", "none", "--format", "{p}")
    compiled = {tuple(line.split(" ")[:2]) for line in tree.splitlines()}
    metadata = json.loads(output("cargo", "metadata", "--locked", "--format-version", "1"))
    known = {(package["name"], "v" + package["version"]): package for package in metadata["packages"]}
    packages = [known[crate] for crate in sorted(compiled)]
    return [package for package in packages if package["source"] is not None]


def texts(package):
    """Texts of the licence files in the crate's folder, by their names."""
    folder = pathlib.Path(package["manifest_path"]).parent
    files = {path for path in folder.iterdir() if path.is_file() and FILE_NAME.match(path.name)}
    files |= {path for path in folder.glob("LICENSES/*") if path.is_file()}
    if package["license_file"]:
        files.add(folder / package["license_file"])
    return {path.name: path.read_text(encoding="utf-8", errors="replace") for path in sorted(files)}


def toolchain_documents():
    return pathlib.Path(output("rustc", "--print", "sysroot").strip()) / "share/doc/rust"


def standard_texts(package):
    """Texts of the licences in a package's expression, for one that comes without, by the toolchain's file names."""
    names = [f"{name}.txt" for name in re.split(r" OR | AND | WITH |/|[() ]", package["license"])]
    paths = [toolchain_documents() / "licenses" / name for name in names]
    return {path.name: path.read_text(encoding="utf-8") for path in paths if path.is_file()}


def standard_library():
    """Notices of Rust's standard library, which the toolchain has as a page."""
    page = toolchain_documents() / "COPYRIGHT-library.html"
    lines = html.unescape(re.sub(r"<[^>]*>", "", page.read_text(encoding="utf-8"))).splitlines()
    return re.sub(r"\n{3,}", "\n\n", "\n".join(line.rstrip() for line in lines)).strip()


def heading(text):
    print(f"\n{'=' * 100}\n{text}\n{'=' * 100}\n")


def main(target):
    # A text that many crates have stands here once.
    numbers = {}
    print("Licences of the code of other projects in the program `jaka`.")
    print("A number refers to the text with this number below the list of crates.")
    heading("Crates")
    for package in crates(target):
        found = texts(package)
        if not found and not package["license"]:
            sys.exit(f"{package['name']} {package['version']} has no licence expression and no text of a licence")
        print(f"{package['name']} {package['version']}: {package['license'] or 'licence by its text'}")
        if not found:
            print(f"    by {', '.join(package['authors']) or package['repository']}; the crate has no text of its own")
            found = standard_texts(package)
        for name, text in found.items():
            print(f"    {name}: text {numbers.setdefault(text, len(numbers) + 1)}")
    for text, number in numbers.items():
        heading(f"Text {number}")
        print(text.rstrip())
    heading("Rust's standard library")
    print(standard_library())
    for end, (name, notice) in RUNTIMES.items():
        if target.endswith(end):
            heading(name)
            print(notice.read_text(encoding="utf-8").rstrip())


if len(sys.argv) != 2:
    sys.exit("usage: release/third_party.py TARGET")
sys.stdout.reconfigure(encoding="utf-8", newline="\n")
main(sys.argv[1])
