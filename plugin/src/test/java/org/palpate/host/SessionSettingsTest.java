package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceSpecification;
import org.palpate.volume.phantom.Phantom;

class SessionSettingsTest {
  private static final ContactScene SCENE =
      new ContactScene(Phantom.parse("sphere:64").segments(), ContactSettings.standard());

  @Test
  void theDefaultStiffnessIsTheScenesUnlessTheDeviceRendersLess() {
    SessionSettings standard = SessionSettings.standard();
    assertEquals(0.5, standard.defaultNewtonPerMm(SCENE, rendering(3)));
    assertEquals(0.3, standard.defaultNewtonPerMm(SCENE, rendering(0.6)));
    assertEquals(2, standard.withDefaultStiffness(2).defaultNewtonPerMm(SCENE, rendering(0.6)));
  }

  @Test
  void aBuilderKeepsTheDefaultOfWhatIsNotGiven() {
    ContactSettings built = ContactSettings.builder(SolverKind.GUARDED).stiffness(0.8).build();
    ContactSettings standard = ContactSettings.standard(SolverKind.GUARDED);
    assertEquals(OptionalDouble.of(0.8), built.stiffnessNewtonPerMm());
    assertEquals(standard.friction(), built.friction());
    assertEquals(standard.collision(), built.collision());
    assertEquals(
        standard,
        ContactSettings.builder(SolverKind.GUARDED).stiffness(OptionalDouble.empty()).build());
  }

  private static DeviceSpecification rendering(double newtonPerMm) {
    return new DeviceSpecification("probe", "", 10, newtonPerMm, 50, 0);
  }
}
