#include "app/program_build.h"

#include "app/child_process.h"
#include "run/atomic_file.h"
#include "run/checksum.h"
#include "run/prm_text.h"
#include "micro/terms/sph_sweeps.h"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <filesystem>

namespace turgor {
namespace {
/// The note of the linker in the program itself, the first of the loaded objects; empty when it was linked
/// without.
std::string build_id() {
  std::string digits;
  ::dl_iterate_phdr(
      [](dl_phdr_info *object, std::size_t, void *result) {
        for (int k = 0; k < object->dlpi_phnum; ++k) {
          const ElfW(Phdr) &segment = object->dlpi_phdr[k];
          if (segment.p_type != PT_NOTE) continue;
          const char *at = reinterpret_cast<const char *>(object->dlpi_addr + segment.p_vaddr),
                     *const end = at + segment.p_memsz;
          while (at + sizeof(ElfW(Nhdr)) <= end) {
            ElfW(Nhdr) note;
            std::memcpy(&note, at, sizeof(note));
            const char *name = at + sizeof(note), *description = name + (note.n_namesz + 3u) / 4u * 4u;
            if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0)
              for (unsigned int byte = 0; byte < note.n_descsz; ++byte)
                for (const int half : {4, 0})
                  *static_cast<std::string *>(result) += "0123456789abcdef"[(description[byte] >> half) & 15];
            at = description + (note.n_descsz + 3u) / 4u * 4u;
          }
        }
        return 1;
      },
      &digits);
  return digits;
}

std::string commit_beside(const std::filesystem::path &program) {
  const std::filesystem::path file = program.string() + ".commit";  // written by the build after linking
  return std::filesystem::is_regular_file(file) ? trimmed(read_whole(file)) : "unknown";
}
}  // namespace

const ProgramBuild &program_build() {
  static const ProgramBuild build = [] {
    ProgramBuild made;
    made.hash = build_id();
    if (made.hash.empty()) made.hash = hexadecimal(fnv1a(read_whole(this_program())));
    made.commit = commit_beside(this_program());
#ifdef __clang__
    made.compiler = std::string("clang ") + __clang_version__;
#else
    made.compiler = std::string("GCC ") + __VERSION__;
#endif
    made.instruction_set = sph::sweeps<2>().name;
    return made;
  }();
  return build;
}
}  // namespace turgor
