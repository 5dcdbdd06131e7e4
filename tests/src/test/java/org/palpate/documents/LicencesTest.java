package org.palpate.documents;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.xpath.XPath;
import javax.xml.xpath.XPathConstants;
import javax.xml.xpath.XPathFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;

/** The page of licences names every library that a module uses outside its tests. */
class LicencesTest {
  private static final Path PAGE = Path.of("docs/licences.md");
  private static final String LIBRARIES =
      "/project/dependencies/dependency[groupId!='org.palpate' and not(scope='test')]/artifactId";

  @ParameterizedTest
  @ValueSource(strings = {"core", "native", "plugin", "benchmarks"})
  void everyLibraryHasALicence(String module) throws Exception {
    String page = Files.readString(Sources.root().resolve(PAGE));
    Set<String> libraries = libraries(Sources.root().resolve(module).resolve("pom.xml").toFile());
    assertTrue(!libraries.isEmpty(), "there are some");
    libraries.removeIf(name -> Pattern.compile("[ `]" + name + "[ `]").matcher(page).find());
    assertTrue(libraries.isEmpty(), () -> libraries + " of " + module + " are not in " + PAGE);
  }

  private static Set<String> libraries(File pom) throws Exception {
    Document document = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(pom);
    XPath path = XPathFactory.newInstance().newXPath();
    NodeList nodes = (NodeList) path.evaluate(LIBRARIES, document, XPathConstants.NODESET);
    Set<String> names = new TreeSet<>();
    for (int n = 0; n < nodes.getLength(); n++) {
      names.add(nodes.item(n).getTextContent());
    }
    return names;
  }
}
