#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "io/table/laboratory_table.hpp"
#include "support/films.hpp"
#include "support/program.hpp"

namespace {
using namespace arenite;
using io::LaboratoryTable;
using io::Quantity;
using test::TemporaryFolder;

const Quantity force{{"force", "f"}, dimension::force, ""};
const Quantity difference{{"temperature", "dt"}, dimension::temperature, "", Quantity::Kind::difference};
const Quantity absolute{{"temperature", "dt"}, dimension::temperature, "", Quantity::Kind::absolute_temperature};

struct Written {
  TemporaryFolder folder;
  std::string path;
  explicit Written(const std::string& text) : path((folder / "a.csv").string()) { test::spill(path, text); }
};

TEST(LaboratoryTable, UnitsInBracketsBelowAndBehindTheName) {
  for (const char* text : {"u,Force [kN]\n1,2.5\n", "u,force\n-,kN\n1,2.5\n", "u,force_kN\n1,2.5\n"}) {
    const Written file(text);
    LaboratoryTable t(file.path);
    ASSERT_TRUE(t.find(force)) << text;
    EXPECT_EQ(t.values(*t.find(force), force), std::vector<double>{2500}) << text;
    EXPECT_TRUE(t.notes().empty());
  }
  const Written file("x,gamma_kN_per_mm\n1,2\n");
  LaboratoryTable t(file.path);
  const Quantity gamma{{"gamma"}, dimension::stiffness, ""};
  EXPECT_EQ(t.values(*t.find(gamma), gamma), std::vector<double>{2e6});
}

TEST(LaboratoryTable, AnAssumedUnitIsNoted) {
  const Written file("u,F\n1,2.5\n");
  LaboratoryTable t(file.path);
  EXPECT_EQ(t.values(*t.find(force), force), std::vector<double>{2.5});
  ASSERT_EQ(t.notes().size(), 1U);
  EXPECT_NE(t.notes()[0].find("states no unit of F, so N was assumed"), std::string::npos);
}

TEST(LaboratoryTable, AUnitInACommentAboveIsTaken) {
  for (const char* comment : {"# units: mm, kN", "# unit = kN", "% Units: kN; mm"}) {
    const Written file(comment + std::string("\nu,F\n1,2.5\n"));
    LaboratoryTable t(file.path);
    EXPECT_EQ(t.values(*t.find(force), force), std::vector<double>{2500}) << comment;
    EXPECT_TRUE(t.notes().empty());
  }
  const Written own("# units: kN\nu,F [N]\n1,2.5\n");
  LaboratoryTable t(own.path);
  EXPECT_EQ(t.values(*t.find(force), force), std::vector<double>{2.5}) << "that of the column wins";
}

TEST(LaboratoryTable, DegreesCelsius) {
  const Written file("u,dT [C]\n1,2.5\n");
  LaboratoryTable t(file.path);
  EXPECT_EQ(t.values(1, difference), std::vector<double>{2.5});
  EXPECT_EQ(t.values(1, absolute), std::vector<double>{275.65});
}

TEST(LaboratoryTable, EveryBadCellIsTold) {
  const Written file("u,force [N]\n1,2.5\n2,x\n3,\n");
  LaboratoryTable t(file.path);
  try {
    t.values(1, force);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 2U);
    EXPECT_EQ(error.problems()[0].line, 3);
    EXPECT_EQ(error.problems()[1].line, 4);
  }
  EXPECT_THROW(t.values(1, difference), InputError);
  const Written bare("u,force\n");
  EXPECT_THROW(LaboratoryTable{bare.path}, InputError);
  const Written holes("u,force [N]\n1,\n2,3\n");
  LaboratoryTable h(holes.path);
  EXPECT_TRUE(std::isnan(h.values(1, force, true)[0]));
}

}  // namespace
