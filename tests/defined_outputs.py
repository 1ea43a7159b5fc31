"""What `turgor parameters SCENE` defines as results, columns and fields: read from the comment lines below the entries."""
import re
import subprocess


def defined_outputs(program, scene):
    """[(file, "name [unit]" with a * for any text, whether every run writes it)]"""
    lines = subprocess.run([program, "parameters", scene], capture_output=True, text=True, check=True, timeout=60).stdout.splitlines()
    found, file = [], None
    for line in lines[lines.index("# What a run leaves in its directory") + 1:]:
        if line.startswith("#      "):
            found[-1][2] += " " + line[7:].strip()
        elif line.startswith("#   "):
            defined, _, text = line[4:].partition(": ")
            found.append([file, defined, text])
        elif re.match(r"# \S+\.(json|csv|xdmf)[:,] ", line):
            file = re.split("[:,]", line[2:])[0]
    assert found, f"nothing is defined for {scene}"
    return [(file, defined, ". Only " not in text) for file, defined, text in found]


def stands_for(defined, name):
    return re.fullmatch(".+".join(map(re.escape, defined.split("*"))), name) is not None
