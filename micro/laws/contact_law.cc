#include "micro/laws/contact_law.h"

#include "run/number_text.h"

#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
template <class Work>
void for_each_law(const Work &work) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (work(std::variant_alternative_t<k, ContactLaw>()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<ContactLaw>>());
}
}  // namespace

std::string contact_law_names() {
  std::string names;
  for_each_law([&](const auto &law) { names += (names.empty() ? "" : "|") + std::string(law.name); });
  return names;
}

std::string contact_law_text() {
  std::string text;
  for_each_law(
      [&](const auto &law) { text += (text.empty() ? "" : "; ") + std::string(law.name) + ": " + law.what; });
  return text;
}

ContactLaw make_contact_law(const std::string &name, const double W) {
  ContactLaw made;
  bool found = false;
  for_each_law([&]<class Law>(Law law) {
    if (name != law.name) return;
    if constexpr (has_adhesion<Law>) law.W = W;
    made = law;
    found = true;
  });
  if (!found) throw std::logic_error("there is no contact law " + name);
  return made;
}

std::string wrong_adhesion(const ContactLaw &law, const double modulus, const double radius,
                           const std::string &radius_entry) {
  return std::visit(
      [&]<class Law>(const Law &one) -> std::string {
        if constexpr (has_adhesion<Law>) {
          if (one.has_history && !(one.W > 0.))
            return "Adhesion is 0, but Law = " + std::string(one.name) +
                   " needs it positive (J/m^2): without adhesion it is Law = hertz.";
          if (one.W > 0.1 * modulus * radius)
            return "Adhesion is " + number_text(one.W) +
                   " J/m^2, but it has to be at most a tenth of Modulus times " + radius_entry + " (" +
                   number_text(0.1 * modulus * radius) + "): contacts would be as wide as the cells.";
        }
        return "";
      },
      law);
}
}  // namespace turgor
