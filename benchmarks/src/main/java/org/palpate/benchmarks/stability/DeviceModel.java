package org.palpate.benchmarks.stability;

import java.util.List;

/**
 * A model of a device. Force and workspace are those that CHAI3D publishes for the device of that
 * name; mass, damping and encoder step are not published with them and are swept or assumed.
 *
 * @param name the name that a person knows
 * @param maxForceNewton the nominal maximum
 * @param maxStiffnessNewtonPerMm the largest stiffness of its specification in the native layer
 * @param handleKg the apparent mass of the handle
 * @param dampingNewtonSecondPerM the physical damping b
 * @param encoderStepMm the smallest step of position
 */
public record DeviceModel(
    String name,
    double maxForceNewton,
    double maxStiffnessNewtonPerMm,
    double handleKg,
    double dampingNewtonSecondPerM,
    double encoderStepMm) {

  /** The devices with known force and stiffness; desktop arms are light, delta robots are not. */
  public static final List<DeviceModel> KNOWN =
      List.of(
          new DeviceModel("Touch", 3.3, 0.4, 0.05, 0.5, 0.055),
          new DeviceModel("Omni", 3.3, 0.7, 0.05, 0.5, 0.055),
          new DeviceModel("Premium 1.5", 8.5, 0.8, 0.075, 0.5, 0.03),
          new DeviceModel("Falcon", 8, 0.75, 0.15, 1, 0.06),
          new DeviceModel("lambda", 12, 0.4, 0.3, 2, 0.0015),
          new DeviceModel("sigma", 12, 0.45, 0.3, 2, 0.0015),
          new DeviceModel("omega", 12, 0.7, 0.2, 2, 0.009),
          new DeviceModel("delta", 20, 0.6, 0.25, 2, 0.03));

  /** Returns this device with another mass. */
  public DeviceModel withHandleKg(double kg) {
    return new DeviceModel(
        name, maxForceNewton, maxStiffnessNewtonPerMm, kg, dampingNewtonSecondPerM, encoderStepMm);
  }

  /** Returns this device with another physical damping. */
  public DeviceModel withDamping(double newtonSecondPerM) {
    return new DeviceModel(
        name, maxForceNewton, maxStiffnessNewtonPerMm, handleKg, newtonSecondPerM, encoderStepMm);
  }

  /** Returns this device with an encoder that is fine enough not to matter. */
  public DeviceModel withFineEncoder() {
    return new DeviceModel(
        name, maxForceNewton, maxStiffnessNewtonPerMm, handleKg, dampingNewtonSecondPerM, 1e-6);
  }
}
