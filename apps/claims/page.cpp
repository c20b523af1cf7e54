#include "claim.hpp"

namespace velum_claims {
namespace {

using velum_plots::escaped;
using velum_plots::Table;

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>What the lectures claim, tested</title>
<style>
body { font-family: "DejaVu Sans", Helvetica, Arial, sans-serif; max-width: 1040px; margin: 2em auto; padding: 0 1em; color: #222; }
h2 { margin-top: 2.4em; border-top: 1px solid #ccc; padding-top: 0.8em; }
table { border-collapse: collapse; margin: 1em 0; font-size: 90%; }
th, td { border-bottom: 1px solid #ddd; padding: 0.25em 0.8em; text-align: left; }
.number { text-align: right; }
.formula { font-family: "DejaVu Sans Mono", monospace; background: #f4f4f4; padding: 0.5em; }
.verdict { font-weight: bold; padding: 0.5em; }
.holds { background: #e0f0da; }
.in-part { background: #fbf1d0; }
.does-not-hold { background: #f6dad5; }
svg { display: block; margin: 1em 0; max-width: 100%; }
</style>
</head>
<body>
)";

const char* class_of(Verdict verdict) {
  constexpr const char* names[] = {"holds", "in-part", "does-not-hold"};
  return names[static_cast<int>(verdict)];
}

std::string paragraph(const std::string& text, const std::string& name = {}) {
  return "<p" + (name.empty() ? "" : " class=\"" + name + "\"") + ">" + escaped(text) + "</p>\n";
}

std::string section(const Claim& claim, std::size_t number) {
  std::string html = "<h2 id=\"claim" + std::to_string(number) + "\">" + std::to_string(number) + ". " +
                     escaped(claim.title) + "</h2>\n";
  html +=
      paragraph(claim.source) + paragraph(claim.formula, "formula") + paragraph("Measured: " + claim.method);
  for (const std::string& figure : claim.figures) html += figure;
  for (const Table& table : claim.tables) html += table.html();
  return html + paragraph(std::string("Verdict: ") + name_of(claim.verdict) + ". " + claim.reason,
                          std::string("verdict ") + class_of(claim.verdict));
}

}  // namespace

std::string page_of(const std::vector<Claim>& claims, const std::vector<Subject>& subjects) {
  std::string html = head;
  html += "<h1>What the lectures claim, tested</h1>\n";
  std::string scenes = "Scenes: ";
  for (const Subject& subject : subjects) {
    scenes += (&subject == &subjects.front() ? "" : ", ") + subject.name + " (" +
              std::to_string(subject.world.triangles.size()) + " triangles)";
  }
  html += paragraph(scenes +
                    ". Counts are the same on every machine; times are processor time of one thread, the "
                    "least of a few runs.");
  Table summary({"claim", "verdict", "because"}, "lll");
  for (const Claim& claim : claims) summary.add({claim.title, name_of(claim.verdict), claim.reason});
  html += summary.html();
  for (std::size_t i = 0; i < claims.size(); ++i) html += section(claims[i], i + 1);
  return html + "</body>\n</html>\n";
}

}  // namespace velum_claims
