#pragma once

/// Names of outputs, and checks of them.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/arguments.h"
#include "geometry/files/mesh_files.h"

namespace morskin::app {

/// What the name of a mesh that is not certified ends in, and of what belongs to it.
inline constexpr std::string_view unverified = ".unverified";

/// The ending of a path, with its dot, in lower case.
std::string lower_extension(const std::filesystem::path& path);

/// "-" and /dev/stdout.
bool is_standard_output(const std::filesystem::path& path);

/// The outputs of `mesh`: meshes, then the report, the certificate, the areas and the trace.
std::vector<std::filesystem::path> all_outputs(const MeshArguments& mesh);

/// Whether one of the outputs of `mesh` goes to standard output, so that the report for people goes
/// elsewhere.
bool takes_standard_output(const MeshArguments& mesh);

/// Prints a report on standard output, or on standard error where the output takes that.
void print_beside(const std::filesystem::path& output, const std::string& report);

/// A standard stream, a device, a pipe; a folder too, which whoever opens it refuses.
bool is_special(const std::filesystem::path& path);

/// Whether two names are of one file, however they are written.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// @throw UsageError if the output has no name or is the molecule's own file.
void check_not_input(const std::filesystem::path& output, const MoleculeArguments& molecule);

/// @throw UsageError unless the outputs of `mesh`, its report included, differ from the input, from
/// each other and from names that the run chooses itself, have known formats, and at most one goes
/// to standard output.
void check_outputs(const MeshArguments& mesh);

/// The format that a name stands for; devices and pipes have no ending and take PLY.
geometry::MeshFormat format_of(const std::filesystem::path& path);

/// Whether that format can hold what --vertex-data asks for.
bool takes_vertex_data(const std::filesystem::path& path);

/// Whether that format has curved triangles.
bool takes_second_order(const std::filesystem::path& path);

/// Whether it is one of MSMS's two files.
bool is_msms(geometry::MeshFormat format);
bool is_msms(const std::filesystem::path& path);

/// Behind each file of MSMS the other: the same name with .face or .vert. Where both are named,
/// nothing is added.
void add_msms_partners(std::vector<std::filesystem::path>& outputs);
/// The other file's name.
std::filesystem::path msms_partner(std::filesystem::path path);

}  // namespace morskin::app
