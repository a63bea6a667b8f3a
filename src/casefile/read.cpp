#include "strandyn/casefile/read.hpp"

#include "document.hpp"
#include "reader.hpp"
#include "resolve.hpp"
#include "text_file.hpp"

namespace strandyn::casefile {

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_scene_text(read_text(file), file.string(), overrides);
}

Scene read_scene_text(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  const Document document = parse_document(text, name, overrides);
  Scene scene;
  scene.source = document.source;
  Findings findings;
  Reader(document.source, document.root, "", findings).read(scene);
  findings.refusals.tell();
  scene.notes = std::move(findings.notes);
  scene.source.entries.merge(findings.places);  // the case's own keys lie on top
  if (scene.title.empty()) scene.title = std::filesystem::path(name).stem().string();
  resolve_scene(scene);
  return scene;
}

}  // namespace strandyn::casefile
