// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/epoch_genomes.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using test::message_of;

namespace {

const std::string phylogeny_header =
    "id,ancestor_list,ancestor_id,origin_time,destruction_time,species,origin,body,genome_id,mutation_distance,tag_at_birth,"
    "tag_at_death,cause_of_death,killer_id\n";

/// A prey with its own genome that dies at 20 s, and predators 1 and 2 that share a genome, changed at the birth of 2 at 10 s.
RunManifest written(const std::filesystem::path& folder) {
  std::ofstream{folder / "phylogeny.csv"} << phylogeny_header << "0,[none],0,0,20,prey,random,0,0,0,1,1,caught,1\n"
                                          << "1,[none],1,0,inf,predator,random,1,1,0,1,,,\n"
                                          << "2,[1],1,10,inf,predator,inherited,2,1,0.5,1,,,\n";
  std::ofstream{folder / "genomes.csv"} << "id,genome_id,time_s,w0,w1,sight_m\n0,0,0,0.25,0.5,6\n1,1,0,1,2,7\n2,1,10,3,4,8\n";
  RunManifest run;
  run.folder = folder;
  run.status = "complete";
  run.reached_s = 30.0;
  run.web = FoodWeb{{"prey", "predator"}, {{.hunter = 1, .victim = 0}}};
  return run;
}

using Weights = std::vector<double>;

}  // namespace

TEST_CASE("epoch genomes: living after the epoch's tick, with the weights that a shared genome had then") {
  const test::TemporaryFolder folder;
  const RunManifest run = written(folder.path());
  const auto living = living_genomes(run, std::vector{0.0, 10.0, 20.0, 30.0});
  REQUIRE(living.size() == 4);
  REQUIRE(living[0].size() == 2);
  CHECK((living[0][0].species == 0 && living[0][0].genome.weights == Weights{0.25, 0.5}));
  CHECK((living[0][1].id == 1 && living[0][1].genome.weights == Weights{1.0, 2.0}));
  REQUIRE(living[1].size() == 3);
  CHECK(living[1][1].genome.weights == Weights{3.0, 4.0});
  CHECK(living[1][2].genome.weights == Weights{3.0, 4.0});
  CHECK((living[0][0].genome.traits == Weights{6.0} && living[0][1].genome.traits == Weights{7.0} &&
         living[1][1].genome.traits == Weights{8.0}));
  CHECK(living[2].size() == 2);
  CHECK(living[3].size() == 2);
}

TEST_CASE("epoch genomes: gaits, bodies and brains that grow -> the genes of genes.csv, those of a shared genome at that time") {
  const test::TemporaryFolder folder;
  const RunManifest run = written(folder.path());
  std::ofstream{folder.path() / "genomes.csv"} << "id,genome_id,time_s\n0,0,0\n1,1,0\n2,1,10\n";
  std::ofstream{folder.path() / "genes.csv"}
      << "id,part,index,value\n0,brain,0,3\n0,gait,0,7\n1,brain,0,0\n2,brain,0,1\n2,brain,1,0.5\n2,body,0,4\n2,body,1,5\n";
  const auto living = living_genomes(run, std::vector{0.0, 10.0});
  CHECK((living[0][0].genome.weights == Weights{3.0} && living[0][1].genome.weights == Weights{0.0}));
  CHECK((living[1][1].genome.weights == Weights{1.0, 0.5} && living[1][2].genome.weights == Weights{1.0, 0.5}));
  CHECK((living[0][0].genome.gait_genes == Weights{7.0} && living[0][0].genome.body_genes.empty()));
  CHECK((living[0][1].genome.body_genes.empty() && living[1][1].genome.body_genes == Weights{4.0, 5.0}));
}

TEST_CASE("epoch genomes: what a run cannot give -> error that names file and reason") {
  const test::TemporaryFolder folder;
  RunManifest run = written(folder.path());
  const auto error = [&](double epoch_s = 10.0) {
    return message_of<std::invalid_argument>([&] { static_cast<void>(living_genomes(run, std::vector{epoch_s})); });
  };
  const std::string manifest = (folder.path() / "manifest.json").string();
  CHECK(error() == "");
  CHECK(error(31.0) == manifest + ": the run reached 30 s: must be >= 31 s, an epoch");
  run.reached_s.reset();
  run.status = "running";
  CHECK(error() == manifest + ": status \"running\": phylogeny.csv has those alive only at a run's end; resume the run");
  run = written(folder.path());
  std::ofstream{folder.path() / "genomes.csv"} << "id,genome_id,time_s,w0,w1\n0,0,0,0.25,0.5\n";
  CHECK(error() == (folder.path() / "genomes.csv").string() + ": has no genome of individual 1");
  std::ofstream{folder.path() / "genomes.csv"} << "id,genome_id,time_s,w0,w1\n0,0,0,0.25,0.5\n1,1,0,1,2\n2,1,10,3,";
  CHECK(error() == (folder.path() / "genomes.csv").string() + ": the last line is truncated; resume the run");
  std::filesystem::remove(folder.path() / "genomes.csv");
  CHECK(error().find("genomes.csv") != std::string::npos);
  std::ofstream{folder.path() / "phylogeny.csv", std::ios::app} << "3,[2],1,10,inf,predator,inherited,2,1,0.5,1,,,\n";
  CHECK(error() == (folder.path() / "phylogeny.csv").string() + ": id 3: ancestor_list = [2]: must be [1], as its ancestor_id");
  std::filesystem::remove(folder.path() / "phylogeny.csv");
  CHECK(error().find("phylogeny.csv") != std::string::npos);
}
