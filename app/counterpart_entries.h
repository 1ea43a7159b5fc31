// What every way of finding the scene of all cells needs (counterpart.h, struck_counterpart.h): the entries
// of an input, numbers in them, and a question to the scene of all cells before a file is written for it.
#pragma once

#include "app/counterpart.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace turgor {
using EntryValues = std::map<std::string, std::string>;

/// All entries of an input by Section/Name.
EntryValues values_of(const Input &input);

bool divides(int factor, const std::string &whole);
std::string halved(const std::string &number);
std::string doubled(const std::string &number);
std::string without_blanks(std::string text);

/// Entries of `scene` that are in a section and that `values` has, too, with their values there.
Counterpart::Entries shared_entries(const EntryValues &values, const std::string &scene,
                                    const ScenarioRegistry &registry);

/// path: Section/Name, or a name alone.
void set_entry(InputEntries &prm, const std::string &path, const std::string &value);

/// Each refinement that RVEs and steps can have, whatever the scene.
void refine_rves_and_steps(Counterpart &cells, const EntryValues &values);

/// A tissue of a file is not compared: throws InputError.
void refuse_files(const Input &tissue);

/// The scene of all cells with its entries set and checked. names: entries of the cells and what the same is
/// called in the input of the tissue, for the sentences. Throws InputError where it cannot be.
std::unique_ptr<Scenario> possible_scene(const Counterpart &cells, const ScenarioRegistry &registry,
                                         const std::vector<std::pair<std::string, std::string>> &names);
}  // namespace turgor
