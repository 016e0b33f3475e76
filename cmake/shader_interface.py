#!/usr/bin/env python3
"""Writes the C++ side of a shader's interface, read from its compiled SPIR-V.

shader_interface.py --type NAME --shared PREFIX=FOLDER... --groups PREFIX=FILE --header FILE --layouts FILE
                    [VARIANT]=WORDS=SPIRV...

The header declares the struct opaline::shaders::NAME with the shader's push constants, its bindings and
its specialization constants by the names that they have in GLSL. Bindings that make up a struct of the
groups' FILE stand there as one field of it, called like the struct. The layouts are static_asserts on the
structs of the FOLDERs that the shader reads or writes. WORDS names the span of the optimised code; SPIRV is the
same shader compiled without optimisation, which keeps names. A variant differs in the kind of a binding
at most.
"""

import argparse
import array
import collections
import pathlib
import re
import sys

# Numbers of the SPIR-V specification.
NAME, MEMBER_NAME = 5, 6
TYPE_INT, TYPE_FLOAT, TYPE_VECTOR, TYPE_MATRIX = 21, 22, 23, 24
TYPE_IMAGE, TYPE_SAMPLED_IMAGE, TYPE_ARRAY, TYPE_RUNTIME_ARRAY, TYPE_STRUCT, TYPE_POINTER = 25, 27, 28, 29, 30, 32
CONSTANT, SPEC_CONSTANT, VARIABLE, DECORATE, MEMBER_DECORATE = 43, 50, 59, 71, 72
TYPE_ACCELERATION_STRUCTURE = 5341
SPEC_ID, ARRAY_STRIDE, NON_WRITABLE, BINDING, OFFSET = 1, 6, 24, 33, 35
UNIFORM_CONSTANT, UNIFORM, PUSH_CONSTANT, STORAGE_BUFFER = 0, 2, 9, 12
DIM_BUFFER = 5

# Of a binding: the class of its field in C++ and its gpu::BindingType.
UNIFORM_BUFFER = ("gpu::Uniform", "UniformBuffer")
READ_BUFFER = ("gpu::Read", "StorageBuffer")
WRITTEN_BUFFER = ("gpu::Write", "StorageBuffer")
TEXELS = ("gpu::Texels", "TexelBuffer")
SAMPLED = ("gpu::Sampled", "SampledImage")
STORAGE_IMAGE = ("gpu::WriteImage", "StorageImage")
STRUCTURE = ("gpu::TexelsOrRays", "AccelerationStructure")


def fail(message):
    sys.exit(f"shader_interface: {message}")


class Module:
    """What a SPIR-V module says of its globals."""

    def __init__(self, path):
        words = array.array("I", pathlib.Path(path).read_bytes())
        self.names, self.member_names = {}, {}
        self.decorations = collections.defaultdict(dict)
        self.member_decorations = collections.defaultdict(dict)
        self.types, self.constants, self.spec_constants, self.variables = {}, {}, [], []
        at = 5
        while at < len(words):
            operation, length = words[at] & 0xFFFF, words[at] >> 16
            self._read(operation, words[at + 1 : at + length])
            at += length

    def _read(self, operation, operands):
        if operation == NAME:
            self.names[operands[0]] = text(operands[1:])
        elif operation == MEMBER_NAME:
            self.member_names[operands[0], operands[1]] = text(operands[2:])
        elif operation == DECORATE:
            self.decorations[operands[0]][operands[1]] = list(operands[2:])
        elif operation == MEMBER_DECORATE:
            self.member_decorations[operands[0], operands[1]][operands[2]] = list(operands[3:])
        elif TYPE_INT <= operation <= TYPE_POINTER or operation == TYPE_ACCELERATION_STRUCTURE:
            self.types[operands[0]] = (operation, list(operands[1:]))
        elif operation == CONSTANT:
            self.constants[operands[1]] = operands[2]
        elif operation == SPEC_CONSTANT:
            self.spec_constants.append((operands[1], operands[0]))
        elif operation == VARIABLE:
            self.variables.append((operands[1], self.types[operands[0]][1][1], operands[2]))

    def members(self, struct):
        """(name, type, offset) of each."""
        return [(self.member_names[struct, i], member, self.member_decorations[struct, i][OFFSET][0])
                for i, member in enumerate(self.types[struct][1])]

    def size(self, type_id, stride=None):
        """Bytes of a type as a host struct of the same members has them."""
        operation, operands = self.types[type_id]
        if operation in (TYPE_INT, TYPE_FLOAT):
            return operands[0] // 8
        if operation in (TYPE_VECTOR, TYPE_MATRIX):
            return self.size(operands[0]) * operands[1]
        if operation == TYPE_ARRAY:
            return self.decorations[type_id][ARRAY_STRIDE][0] * self.constants[operands[1]]
        name, last, offset = self.members(type_id)[-1]
        return offset + self.size(last)


def text(words):
    return words.tobytes().split(b"\0")[0].decode()


def host_type(module, type_id, shared):
    """The C++ type of a push constant, and the shared header that has it."""
    operation, operands = module.types[type_id]
    if operation == TYPE_INT:
        return ("std::int32_t" if operands[1] else "std::uint32_t"), None
    if operation == TYPE_FLOAT:
        return "float", None
    if operation == TYPE_VECTOR:
        prefix = {TYPE_FLOAT: "", TYPE_INT: "u"}[module.types[operands[0]][0]]
        return f"glm::{prefix}vec{operands[1]}", f"<glm/vec{operands[1]}.hpp>"
    if operation == TYPE_STRUCT:
        name = module.names[type_id]
        if name in shared:
            return f"shared::{name}", f'"{shared[name]}"'
    fail("push constants are numbers, vectors and structs of shared folders")


def field_name(module, variable, struct):
    """An anonymous block goes by its only member's name."""
    name = module.names.get(variable, "")
    return name or module.member_names[struct, 0]


def bindings_of(module):
    """binding -> (name, kind)"""
    found = {}
    for variable, pointed, storage in module.variables:
        if BINDING not in module.decorations[variable]:
            continue
        operation, operands = module.types[pointed]
        if storage == UNIFORM:
            kind = UNIFORM_BUFFER
        elif storage == STORAGE_BUFFER:
            members = range(len(operands))
            fixed = all(NON_WRITABLE in module.member_decorations[pointed, i] for i in members)
            kind = READ_BUFFER if fixed or NON_WRITABLE in module.decorations[variable] else WRITTEN_BUFFER
        elif operation == TYPE_ACCELERATION_STRUCTURE:
            kind = STRUCTURE
        elif operation == TYPE_SAMPLED_IMAGE:
            kind = SAMPLED
        elif operation == TYPE_IMAGE and operands[1] == DIM_BUFFER:
            kind = TEXELS
        else:
            kind = STORAGE_IMAGE
        (binding,) = module.decorations[variable][BINDING]
        name = field_name(module, variable, pointed)
        if binding in found:
            fail(f"{name} and {found[binding][0]} are both at binding {binding}")
        found[binding] = (name, kind)
    return found


def push_of(module, shared):
    """(name, C++ type, header, offset) of each, and the bytes of all."""
    for _, pointed, storage in module.variables:
        if storage == PUSH_CONSTANT:
            members = [(name, *host_type(module, member, shared), offset)
                       for name, member, offset in module.members(pointed)]
            return members, (module.size(pointed) + 3) // 4 * 4
    return [], 0


def constants_of(module):
    """(name, C++ type) of constant_id 0, 1, 2, …; those from 16 on are the device's (gpu::WorkGroups)."""
    found = {}
    for constant, type_id in module.spec_constants:
        number = module.decorations[constant].get(SPEC_ID)
        if number and number[0] < 16 and constant in module.names:  # a group's size has none, and may share a number
            found[number[0]] = (module.names[constant], host_type(module, type_id, {})[0])
    if sorted(found) != list(range(len(found))):
        fail("specialization constants have names and the numbers 0, 1, 2, …")
    return [found[number] for number in sorted(found)]


def merged(variants):
    """The bindings of all variants: binding -> (name, field's class)."""
    names = [{binding: name for binding, (name, _) in found.items()} for found in variants]
    if any(other != names[0] for other in names):
        fail("the variants of a shader have the same bindings by the same names")
    fields = {}
    for binding in sorted(variants[0]):
        kinds = {found[binding][1] for found in variants}
        if TEXELS in kinds:
            kinds -= {READ_BUFFER}
        if STRUCTURE in kinds:
            kinds -= {TEXELS}
        if len(kinds) != 1:
            fail(f"the variants of a shader differ in what is at binding {binding}")
        fields[binding] = (variants[0][binding][0], kinds.pop()[0])
    return fields


def groups_in(path):
    """struct -> binding's (name, field's class) -> the path to it in the struct. A group may be a member of a later one."""
    groups = {}
    for struct, members in re.findall(r"^struct (\w+) {\n((?:  [\w:]+ \w+;\n)+)};", pathlib.Path(path).read_text(),
                                      re.MULTILINE):
        groups[struct] = {}
        for kind, name in re.findall(r"([\w:]+) (\w+);", members):
            inner = {of: f"{name}.{place}" for of, place in groups[kind].items()} if kind in groups else {(name, kind): name}
            groups[struct].update(inner)
    return groups


def grouped(fields, groups):
    """The members of Bindings, (class, name) of each, and name -> the path to it there."""
    left = dict.fromkeys(fields.values())
    paths = {name: name for name, _ in left}
    members = []
    for struct, places in reversed(groups.items()):
        if places.keys() <= left.keys():
            group = struct[0].lower() + struct[1:]
            members.append((struct, group))
            for name, kind in places:
                paths[name] = f"{group}.{places[name, kind]}"
                del left[name, kind]
    return [*members, *((kind, name) for name, kind in left)], paths


def fields_of(struct, members):
    lines = "".join(f"    {kind} {name};\n" for name, kind in members)
    return f"  struct {struct} {{\n{lines}  }};\n"


def require_few_buffers(shader, variants):
    """Each within what is asked of a device."""
    choice = pathlib.Path(__file__).resolve().parents[1] / "src/gpu/device_choice.h"
    for variant, found in variants:
        limit = "storageBuffersForTexels" if variant else "storageBuffersOfStage"
        most = int(re.search(rf"{limit} = (\d+);", choice.read_text())[1])
        count = sum(kind[1] == "StorageBuffer" for _, kind in found.values())
        if count > most:
            fail(f"{shader} has {count} storage buffers, and devices may have {most}: {limit} in {choice.name}")


def header_text(arguments, modules, shared):
    variants = [bindings_of(module) for _, _, module in modules]
    push, push_bytes = push_of(modules[0][2], shared)
    constants = constants_of(modules[0][2])
    for _, _, module in modules[1:]:
        if push_of(module, shared)[0] != push or constants_of(module) != constants:
            fail("the variants of a shader have the same push constants and specialization constants")
    names = [name for name, _, _ in modules]
    require_few_buffers(arguments.type, zip(names, variants))
    if any(kind == TEXELS for _, kind in variants[0].values()) and "storage" not in names:
        fail(f"{arguments.type} reads texels and has no variant that reads storage: configure anew")
    fields = merged(variants)
    prefix, groups_file = arguments.groups.split("=")
    members, places = grouped(fields, groups_in(groups_file))

    headers = sorted({header for _, _, header, _ in push if header})
    out = "// Made by cmake/shader_interface.py.\n#pragma once\n\n#include <array>\n#include <cstddef>\n"
    out += "#include <cstdint>\n#include <span>\n\n" + "".join(f"#include {header}\n" for header in headers)
    out += f'#include "gpu/binding.h"\n#include "gpu/shader.h"\n#include "{prefix}/{pathlib.Path(groups_file).name}"\n'
    out += '\nnamespace opaline::shaders {\n\n'
    out += "// Names are those of GLSL. NOLINTBEGIN\n"
    out += "".join(f"extern const std::span<const std::uint32_t> {words};\n" for _, words, _ in modules)
    out += f"\nstruct {arguments.type} {{\n"
    out += fields_of("Push", [(name, f"gpu::Required<{kind}>") for name, kind, _, _ in push])
    out += fields_of("Constants", [(name, f"gpu::Required<{kind}>") for name, kind in constants])
    out += "  struct Bindings {\n"
    out += "".join(f"    {kind} {name};\n" for kind, name in members)
    listed = ", ".join(f"{places[name]}.at({binding})" for binding, (name, _) in fields.items())
    out += f"    std::array<gpu::Binding, {len(fields)}> list() const {{ return {{{listed}}}; }}\n  }};\n"
    for (variant, words, _), found in zip(modules, variants):
        slots = ", ".join(f"{{{binding}, gpu::BindingType::{kind[1]}}}" for binding, (_, kind) in sorted(found.items()))
        suffix = variant.title().replace("_", "")
        out += f"  static constexpr std::array<gpu::BindingSlot, {len(found)}> slots{suffix}{{{{{slots}}}}};\n"
    # The last that a device may have: those of a variant come after those that it has as well.
    out += "  static gpu::Shader shader([[maybe_unused]] gpu::ShaderVariant variant = gpu::ShaderVariant::Texels) {\n"
    for variant, words, _ in reversed(modules):
        suffix = variant.title().replace("_", "")
        test = f"if (variant >= gpu::ShaderVariant::{suffix}) " if variant else ""
        out += f"    {test}return {{{words}, slots{suffix}, {push_bytes}}};\n"
    out += "  }\n"
    out += "};\n"
    for name, _, _, offset in push:
        out += f"static_assert(offsetof({arguments.type}::Push, {name}) == {offset});\n"
    return out + "// NOLINTEND\n\n}  // namespace opaline::shaders\n"


def layouts_text(modules, shared):
    """Asserts on every shared struct that stands in a buffer, once for each way it is laid out."""
    lines, used = set(), set()
    for _, _, module in modules:
        for struct, (operation, _) in module.types.items():
            name = module.names.get(struct)
            if operation != TYPE_STRUCT or name not in shared or OFFSET not in module.member_decorations[struct, 0]:
                continue
            used.add(shared[name])
            for member, _, offset in module.members(struct):
                lines.add(f"static_assert(offsetof(opaline::shared::{name}, {member}) == {offset});\n")
        for type_id, (operation, operands) in module.types.items():
            if operation in (TYPE_ARRAY, TYPE_RUNTIME_ARRAY) and ARRAY_STRIDE in module.decorations[type_id]:
                name = module.names.get(operands[0])
                if module.types[operands[0]][0] == TYPE_STRUCT and name in shared:
                    (stride,) = module.decorations[type_id][ARRAY_STRIDE]
                    lines.add(f"static_assert(sizeof(opaline::shared::{name}) == {stride});\n")
    includes = "".join(f'#include "{header}"\n' for header in sorted(used))
    return "// Made by cmake/shader_interface.py.\n#include <cstddef>\n" + includes + "".join(sorted(lines))


def shared_structs(folders):
    """struct -> header, as C++ includes it"""
    return {name: f"{prefix}/{header.name}" for prefix, folder in (pair.split("=") for pair in folders)
            for header in sorted(pathlib.Path(folder).glob("*.h"))
            for name in re.findall(r"^struct (\w+)", header.read_text(), re.MULTILINE)}


def main():
    parser = argparse.ArgumentParser()
    for option in ("--type", "--groups", "--header", "--layouts"):
        parser.add_argument(option, required=True)
    parser.add_argument("--shared", nargs="+", required=True)
    parser.add_argument("variants", nargs="+")
    arguments = parser.parse_args()
    modules = []
    for variant in arguments.variants:
        name, words, spirv = variant.split("=")
        modules.append((name, words, Module(spirv)))
    shared = shared_structs(arguments.shared)
    for path, content in ((arguments.header, header_text(arguments, modules, shared)),
                          (arguments.layouts, layouts_text(modules, shared))):
        pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
        pathlib.Path(path).write_text(content)


if __name__ == "__main__":
    main()
