// Scenario rve_response: the stress of one RVE along a prescribed path of F(t), F_dot(t), or
// at one F given by hand, beside the flat-wall closed form. Writes stress.csv.
#pragma once

#include "run/scenario.h"
#include "rve/rve.h"
#include "rve/rve_parameters.h"

#include <vector>

namespace turgor {
/// Of F, found so that P there is zero.
enum class FreeComponent { none, xx, yy };
constexpr const char *words_of(FreeComponent) { return "none|xx|yy"; }

class RveResponse : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  struct Asked {
    double time;  ///< s
    Tensor2<2> F, F_dot;
  };
  std::vector<Asked> all_asked() const;
  /// With the free component of F found and put into `asked`. Throws RunFailed where there is no stress.
  RveAnswer<2> answer(const Rve<2> &cells, const RveState<2> &state, Asked &asked, double since,
                      Rve<2>::Workspace &workspace) const;

  RveParameters rve;
  std::string path = "0 : 1, 0; 0, 1 | 1e-3 : 1, 0.3; 0, 1";
  std::string F_by_hand, F_dot_by_hand;
  FreeComponent free_component = FreeComponent::none;
  unsigned int points = 31;
};

std::unique_ptr<Scenario> make_rve_response();
}  // namespace turgor
