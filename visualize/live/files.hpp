#pragma once
// The files that have been opened in a page: there is no disk.

#include <map>
#include <optional>
#include <string>

#include "request/inputs.hpp"

namespace gradus::live {

/// Files by their names without folders, as browsers hand them over.
class OpenedFiles : public Files {
 public:
  /// Keeps a file; one of the same name before it, and its picture, is forgotten.
  void keep(const std::string& name, std::string bytes);
  /// What a kept file shows, decoded: there is no library for PNG or JPEG here. Throws UsageError for a file
  /// that is not kept.
  void keep_picture(const std::string& name, Image picture);

  /// Of a name without folders; what is not kept may come with the project (shipped_model). Throws
  /// UsageError.
  GivenFile open(const std::string& name, const std::string& flag) override;
  /// By the last part of the name in the model, without the folders before it.
  pipeline::FileReader beside(const GivenFile& model, Took took) override;
  /// Throws UsageError for a file whose picture is not kept, InputError for more pixels than are taken.
  Image picture(const GivenFile& file, const std::string& called, std::int64_t most_pixels) override;

 private:
  struct Kept {
    std::string bytes;
    std::optional<Image> picture{};
  };
  std::optional<std::string> bytes_of(const std::string& name) const;

  std::map<std::string, Kept> kept_;
};

}  // namespace gradus::live
