package org.palpate.imagej.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.Macro;
import ij.Prefs;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.Stacks;
import org.palpate.imagej.stack.TouchRefusedException;

class StackProposalTest {
  @AfterEach
  void forgetPreferences() {
    Prefs.set("palpate.lower", null);
    Prefs.set("palpate.upper", null);
  }

  private static StackProposal proposal(ImagePlus image) throws TouchRefusedException {
    return StackProposal.of(StackVolume.shownIn(image), false);
  }

  /** Returns a stack of three matters whose values spread. */
  private static ImagePlus matters(int bits, double factor) {
    return Stacks.of(
        bits, 30, 30, 30, (i, j, k) -> factor * (20 * (i / 10) + 100 * (i / 20) + (j * 7 + k) % 9));
  }

  @Test
  void greyValuesAreDividedWithTheReason() throws TouchRefusedException {
    StackProposal found = proposal(matters(8, 1));
    assertTrue(found.lower() > 28 && found.lower() < 140, found.toString());
    assertEquals(255, found.upper(), "every brighter value belongs to it");
    assertEquals(
        "Proposed: bone, because these values split the histogram into three classes, by Otsu's"
            + " method.",
        found.reason());
  }

  @ParameterizedTest
  @CsvSource({"8, 1, 255", "16, 300, 65535", "32, 1, 148"})
  void theUpperEndIsTheLargestThatAPixelCanHave(int bits, double factor, double upper)
      throws TouchRefusedException {
    assertEquals(upper, proposal(matters(bits, factor)).upper());
  }

  @Test
  void hounsfieldUnitsAreRecognizedByTheirCalibration() throws TouchRefusedException {
    ImagePlus image =
        Stacks.of(16, 30, 30, 8, (i, j, k) -> 32768 + (i < 10 ? -1000 : 40 * (i - 10)) + j % 5);
    image.getCalibration().setSigned16BitCalibration();
    StackProposal found = proposal(image);
    assertEquals(250, found.lower());
    assertEquals(32767, found.upper());
    assertTrue(found.reason().contains("Hounsfield"), found.reason());
  }

  @Test
  void labelsAndMacrosGetTheLastValues() throws TouchRefusedException {
    ImagePlus mask = Stacks.of(8, 9, 9, 9, (i, j, k) -> i > 4 ? 255 : 0);
    assertEquals(new StackProposal(1, 65535, ""), proposal(mask));
    Prefs.set("palpate.lower", 7.0);
    Prefs.set("palpate.upper", 9.0);
    assertEquals(new StackProposal(7, 9, ""), proposal(mask));
    assertEquals(
        new StackProposal(7, 9, ""), StackProposal.of(StackVolume.shownIn(matters(8, 1)), true));
  }

  @Test
  void aPathIsRefusedIfItIsMissingOrNone() throws TouchRefusedException {
    assertEquals(Path.of("a b.csv"), FilePaths.of("volume", " a b.csv "));
    assertEquals(
        "The volume is missing: enter its path.",
        assertThrows(TouchRefusedException.class, () -> FilePaths.of("volume", " ")).getMessage());
    assertEquals(
        "This is not a valid path of a folder: a\0",
        assertThrows(TouchRefusedException.class, () -> FilePaths.of("folder", "a\0"))
            .getMessage());
  }

  @Test
  void theEndOfAMacroIsNoFailure() {
    assertTrue(ErrorDialogs.endsMacro(new RuntimeException(Macro.MACRO_CANCELED)));
    assertFalse(ErrorDialogs.endsMacro(new RuntimeException("other")));
    assertFalse(ErrorDialogs.endsMacro(new IllegalStateException()));
  }
}
