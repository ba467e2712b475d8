#pragma once
// What comes with the program: the gallery's lecture, its pictures and models.

#include <string>
#include <string_view>
#include <vector>

namespace gradus::cli {

/// The path of a file by its name from the project's root, "examples/gallery.json": here, or in a folder
/// above the program, in a clone or where it was installed. Empty when it is nowhere.
std::string shipped(const std::string& name);

/// The path of a model, a picture, a scene or a demo's data that is called by its bare name: "letter_f.obj",
/// "letter_f", "horse.png", "town.json". Empty for any other name.
std::string shipped_example(std::string_view name);

/// The names of the models (".obj"), pictures (".png") or scenes (".json") that come with the program,
/// sorted.
std::vector<std::string> shipped_examples(std::string_view ending);

}  // namespace gradus::cli
