package org.palpate.benchmarks.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StudyDurationTest {
  @ParameterizedTest
  @CsvSource({
    "0.2, about 1 s",
    "89.4, about 89 s",
    "90, about 2 min",
    "605, about 10 min",
    "5399, about 90 min",
    "5400, about 1.5 h",
    "36000, about 10.0 h"
  })
  void aDurationIsReadInItsLargestUnit(double seconds, String text) {
    assertEquals(text, StudyDuration.text(seconds, List.of(), false));
  }

  @Test
  void studiesAddUpAndQuickOnesAreTheirOwn() {
    List<StudyDuration> studies = List.of(StudyDuration.SYNC, StudyDuration.SURFACES);
    assertEquals("about 3 min", StudyDuration.text(60, studies, false), "60 + 83 + 38 s");
    assertEquals("about 2 min", StudyDuration.text(60, studies, true), "60 + 22 + 38 s");
  }

  @Test
  void aStudyThatWasNeverTimedIsNamedBesideTheOthers() {
    List<StudyDuration> studies =
        List.of(StudyDuration.CARVE, StudyDuration.CPP, StudyDuration.ELASTIC);
    assertEquals(
        "about 56 s, and a while that was never timed for --carve, --elastic",
        StudyDuration.text(0, studies, false));
    assertEquals(
        "a while that was never timed for --carve",
        StudyDuration.text(0, List.of(StudyDuration.CARVE), false));
    assertEquals("about 4 min", StudyDuration.text(0, studies, true), "60 + 56 + 110 s");
  }

  @Test
  void anAttackLastsAsItsFramesDo() {
    assertEquals(4, StudyDuration.stressSeconds(100_000));
  }
}
