#include "app/side_file.h"

#include <utility>

#include "app/output_names.h"
#include "app/staged_outputs.h"

namespace morskin::app {

SideFile::SideFile(const std::optional<std::filesystem::path>& name, IfUnverified doubt,
                   std::span<geometry::PendingFile>& staged)
    : name_(name), doubt_(doubt) {
  if (!name || geometry::is_written_directly(*name)) return;
  file_ = &staged.back();
  staged = staged.first(staged.size() - 1);
  if (doubt == IfUnverified::Marked) check_unverified_name(*file_);
}

void SideFile::write(std::string text) {
  if (file_ != nullptr) return file_->write(text);
  text_ = std::move(text);
}

void SideFile::commit(bool is_certified) {
  if (file_ == nullptr) return;
  file_->commit(is_certified || doubt_ == IfUnverified::Same ? "" : unverified);
}

void SideFile::write_directly(bool is_certified) const {
  if (!name_ || file_ != nullptr) return;
  if (is_certified || doubt_ == IfUnverified::Same) geometry::write_file_atomically(*name_, text_);
}

}  // namespace morskin::app
