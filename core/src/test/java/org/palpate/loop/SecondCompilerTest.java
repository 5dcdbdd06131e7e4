package org.palpate.loop;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.management.Attribute;
import javax.management.AttributeList;
import javax.management.DynamicMBean;
import javax.management.JMException;
import javax.management.MBeanException;
import javax.management.MBeanInfo;
import javax.management.MBeanServer;
import javax.management.MBeanServerFactory;
import javax.management.ObjectName;
import javax.management.ReflectionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class SecondCompilerTest {
  private static final String WORK =
      "1138       4       org.palpate.proxy.exact.GuardedSolver::slide (301 bytes)\n";
  private static final String FIRST = "C1 compile queue:\n";
  private static final String SECOND = "C2 compile queue:\n";
  private static final String EMPTY = "Empty\n\n";

  /** Keeps the compiler from leaving out the work. */
  private volatile long result;

  @Test
  void isBusyWhileAMethodIsCompiled() {
    String current = "Current compiles: \nC2 CompilerThread0  " + WORK + "\n";
    assertTrue(SecondCompiler.isBusy(current + FIRST + EMPTY + SECOND + EMPTY));
  }

  @Test
  void isBusyWhileAMethodWaits() {
    assertTrue(
        SecondCompiler.isBusy("Current compiles: \n\n" + FIRST + EMPTY + SECOND + WORK + "\n"));
  }

  @Test
  void graalIsASecondCompilerToo() {
    String second = "JVMCI compile queue:\n";
    String idle = "Current compiles: \n\n" + FIRST + EMPTY + second;
    assertTrue(SecondCompiler.isBusy(idle + WORK + "\n"));
    assertFalse(SecondCompiler.isBusy(idle + EMPTY));
    for (String name : List.of("JVMCI", "JVMCI-native")) {
      String current = "Current compiles: \n" + name + " CompilerThread0  " + WORK + "\n";
      assertTrue(SecondCompiler.isBusy(current + FIRST + EMPTY + second + EMPTY));
    }
  }

  @Test
  void theFirstCompilerDoesNotMatter() {
    String current = "Current compiles: \nC1 CompilerThread0  " + WORK + "\n";
    assertFalse(SecondCompiler.isBusy(current + FIRST + WORK + "\n" + SECOND + EMPTY));
    assertFalse(SecondCompiler.isBusy(current + FIRST + WORK + "\n"), "the only compiler");
  }

  @Test
  @Timeout(value = 1, unit = TimeUnit.MINUTES)
  void theCompilerOfThisJvmIsSeenAtWorkAndIdle() throws InterruptedException {
    SecondCompiler compiler = new SecondCompiler();
    while (!compiler.getAsBoolean()) {
      result = hash(result);
    }
    while (compiler.getAsBoolean()) {
      Thread.sleep(1);
    }
  }

  @Test
  void aJvmWithoutDiagnosticCommandsIsAskedHowLongItHasCompiled() {
    SecondCompiler compiler = new SecondCompiler(MBeanServerFactory::newMBeanServer);
    assertTrue(compiler.getAsBoolean(), "it has compiled since it started");
  }

  @Test
  void aJvmWithoutTheListIsAskedHowLongItHasCompiled() {
    assertTrue(planted(new ReflectionException(new NoSuchMethodException())).getAsBoolean());
  }

  @Test
  void anyOtherErrorOfTheListIsReportedWithItsCause() {
    List<JMException> errors =
        List.of(
            new MBeanException(new IllegalStateException("the list is broken")),
            new ReflectionException(new ClassNotFoundException("a parameter")));
    for (JMException error : errors) {
      SecondCompiler compiler = planted(error);
      IllegalStateException failure =
          assertThrows(IllegalStateException.class, compiler::getAsBoolean);
      assertSame(error, failure.getCause());
    }
  }

  /** Returns a compiler whose list is refused with an error. */
  private static SecondCompiler planted(JMException error) {
    MBeanServer server = MBeanServerFactory.newMBeanServer();
    try {
      server.registerMBean(
          new Refusing(error), new ObjectName("com.sun.management:type=DiagnosticCommand"));
    } catch (JMException e) {
      throw new IllegalStateException(e);
    }
    return new SecondCompiler(() -> server);
  }

  /** Diagnostic commands that all end with an error. */
  private static final class Refusing implements DynamicMBean {
    private final JMException error;

    Refusing(JMException error) {
      this.error = error;
    }

    @Override
    public Object invoke(String name, Object[] values, String[] signature)
        throws MBeanException, ReflectionException {
      if (error instanceof MBeanException thrown) {
        throw thrown;
      }
      throw (ReflectionException) error;
    }

    @Override
    public Object getAttribute(String name) {
      return null;
    }

    @Override
    public void setAttribute(Attribute attribute) {}

    @Override
    public AttributeList getAttributes(String[] names) {
      return new AttributeList();
    }

    @Override
    public AttributeList setAttributes(AttributeList attributes) {
      return new AttributeList();
    }

    @Override
    public MBeanInfo getMBeanInfo() {
      return new MBeanInfo(Refusing.class.getName(), "", null, null, null, null);
    }
  }

  /** Takes the second compiler some work. */
  private static long hash(long seed) {
    long hash = seed;
    for (int n = 0; n < 10_000; n++) {
      hash = Long.rotateLeft(hash * 0x9E3779B97F4A7C15L + n, 31);
    }
    return hash;
  }
}
