#include "app/run_ending.h"

#include "app/ranks.h"
#include "run/number_text.h"
#include "run/output_failed.h"
#include "run/run_context.h"

#include <filesystem>
#include <new>

namespace turgor {
std::string words_of(const std::exception &problem) {
  if (const auto *file = dynamic_cast<const std::filesystem::filesystem_error *>(&problem))
    return "cannot use " + file->path1().string() + ": " + file->code().message() + ".";
  if (dynamic_cast<const std::bad_alloc *>(&problem) != nullptr)
    return "There is not enough memory for this run: take fewer cells, particles or elements.";
  return problem.what();
}

int code_of(const std::exception &problem) {
  const auto *file = dynamic_cast<const std::filesystem::filesystem_error *>(&problem);
  return file != nullptr && file->code() == std::errc::filename_too_long ? 2 : 1;
}

Ending ending_of(const std::function<void()> &action) {
  try {
    action();
    return {};
  } catch (const RunStopped &why) {
    return {130, "stopped", why.what()};
  } catch (const InputError &why) {
    return {2, "failed", why.what()};
  } catch (const OutputFailed &why) {
    return {1, "failed", why.what(), true};
  } catch (const std::exception &why) {
    return {code_of(why), "failed", words_of(why)};
  }
}

bool agree_on_ending(Ending &ending, const MpiSession *mpi) {
  if (mpi == nullptr || mpi->size() == 1) return true;
  // A writer that has a large checkpoint to bring to a slow disk is waited for longer than those who write
  // nothing.
  const double patience = mpi->rank() == 0 ? 5. : 20.;  // s
  const auto severity = [](const int code) { return code == 0 ? 0 : code == 130 ? 1 : code == 2 ? 2 : 3; };
  const auto worst = mpi->worst_at_end(severity(ending.code), patience);
  if (!worst) {
    ending.message = "rank " + number_text(mpi->rank()) + ": " + ending.message;
    return false;
  }
  const std::string told = mpi->told_by(worst->rank, ending.message);
  if (worst->severity > severity(ending.code))
    ending = {worst->severity == 1   ? 130
              : worst->severity == 2 ? 2
                                     : 1,
              worst->severity == 1 ? "stopped" : "failed", "rank " + number_text(worst->rank) + ": " + told};
  return true;
}
}  // namespace turgor
