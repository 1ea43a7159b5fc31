// Which program this is, for summary.json, checkpoints and every cache of runs.
#pragma once

#include <string>

namespace turgor {
struct ProgramBuild {
  std::string hash;      ///< of the executable: the linker's build id
  std::string commit;    ///< of the sources when it was linked, "-changed" behind it if they were not all
                         ///< committed; or "unknown"
  std::string compiler;  ///< "GCC 12.2.0"
  std::string instruction_set;  ///< of the widest kernels on this processor: "avx512"
};

const ProgramBuild &program_build();
}  // namespace turgor
