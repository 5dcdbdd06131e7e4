package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DisplayScaleTest {
  @ParameterizedTest
  @CsvSource({"1,1", "1.5,1.5", "2,2", "2.0x,2", "150%,1.5", "192dpi,2", "0.5,1", "none,1", "99,8"})
  void theScaleIsParsedAsAwtDoes(String setting, double scale) {
    assertEquals(scale, DisplayScale.of(name -> setting, name -> null));
    assertEquals(scale, DisplayScale.of(name -> null, Map.of("J2D_UISCALE", setting)::get));
  }

  @Test
  void aWindowThatNewtScalesIsNotScaledAgain() {
    assertEquals(1, DisplayScale.of(name -> "2", Map.of("GDK_SCALE", "2")::get));
  }
}
