#include <pleura/x3d/encoding/document_builder.h>
#include <pleura/x3d/encoding/reader.h>
#include <pleura/x3d/encoding/sax_parser.h>

namespace pleura {

Document Reader::readFile(const std::filesystem::path& file) {
  try {
    const auto source = SourceText::fromFile(file);
    reading_.push_back(std::filesystem::weakly_canonical(file));
    Document document = readText(source, std::filesystem::absolute(file).parent_path());
    reading_.pop_back();
    return document;
  } catch (const FileError& error) {
    diagnostics_.error({}, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    diagnostics_.error({}, error.what());
  }
  return {};
}

Document Reader::readText(const SourceText& source, const std::filesystem::path& folder) {
  const bool isFirst = root_.empty();
  if (isFirst) root_ = std::filesystem::weakly_canonical(folder);
  DocumentBuilder builder(*this, source, folder);
  parseXml(source, builder, diagnostics_);
  Document document = builder.finish();
  if (isFirst) root_.clear();
  return document;
}

}  // namespace pleura
