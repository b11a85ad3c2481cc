import sys
import fake_wx, IDEFrame
from PLCControler import PLCControler
project = PLCControler()
project.OpenXMLFile(sys.argv[1])
text, errors, warnings = project.GenerateProgram(sys.argv[2])
sys.exit(str(errors) if errors else 0)
