package org.palpate.benchmarks.stability;

import java.util.List;

/**
 * A device as the model has it. Force and workspace are as published by CHAI3D for the device of
 * that name; mass, damping and encoder step are not published with them and are swept or assumed.
 *
 * @param name as a person knows it
 * @param maxForceNewton nominal maximum
 * @param maxStiffnessNewtonPerMm largest stiffness of its specification in the native layer
 * @param handleKg apparent mass of the handle
 * @param dampingNewtonSecondPerM physical damping b
 * @param encoderStepMm smallest step of position
 */
public record DeviceModel(
    String name,
    double maxForceNewton,
    double maxStiffnessNewtonPerMm,
    double handleKg,
    double dampingNewtonSecondPerM,
    double encoderStepMm) {

  /** The devices of which force and stiffness are known; desktop arms are light, deltas are not. */
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

  /** The same with another mass. */
  public DeviceModel withHandleKg(double kg) {
    return new DeviceModel(
        name, maxForceNewton, maxStiffnessNewtonPerMm, kg, dampingNewtonSecondPerM, encoderStepMm);
  }

  /** The same with another physical damping. */
  public DeviceModel withDamping(double newtonSecondPerM) {
    return new DeviceModel(
        name, maxForceNewton, maxStiffnessNewtonPerMm, handleKg, newtonSecondPerM, encoderStepMm);
  }

  /** The same with an encoder that is as fine as the model's time steps. */
  public DeviceModel withFineEncoder() {
    return new DeviceModel(
        name, maxForceNewton, maxStiffnessNewtonPerMm, handleKg, dampingNewtonSecondPerM, 1e-6);
  }
}
