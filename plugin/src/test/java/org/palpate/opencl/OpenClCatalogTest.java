package org.palpate.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.opencl.OpenClCatalog.WrongChoiceException;

class OpenClCatalogTest {
  private static final String NO_DOUBLES = "the device has no double-precision numbers";

  private static JoclDevices.Found device(String name, String why) {
    return new JoclDevices.Found(null, new OpenClCatalog.Entry(name, "platform", true, why));
  }

  private final List<JoclDevices.Found> all =
      List.of(device("Old Card", NO_DOUBLES), device("Card A", ""), device("Card B", ""));

  private String chosen(String part) {
    return OpenClCatalog.choose(all, part).entry().name();
  }

  @Test
  void takesTheFirstDeviceThatFitsAndCanBeUsed() {
    assertEquals("Card A", chosen(""));
    assertEquals("Card A", chosen("card"));
    assertEquals("Card B", chosen("card b"));
  }

  @Test
  void aDeviceWithoutDoublesIsRefusedByItsReason() {
    assertEquals(
        NO_DOUBLES, assertThrows(WrongChoiceException.class, () -> chosen("old")).getMessage());
  }

  @Test
  void aNameThatNoDeviceHasIsRefused() {
    assertThrows(WrongChoiceException.class, () -> chosen("other"));
  }

  @Test
  void withoutAnyDeviceTheNameIsNotToBlame() {
    assertThrows(IllegalStateException.class, () -> OpenClCatalog.choose(List.of(), "card"));
  }
}
