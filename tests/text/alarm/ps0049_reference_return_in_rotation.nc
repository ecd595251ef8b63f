O1 (PS0049: G28 before G69)
G68 X0 Y0 R30.
G28 X0 (expect alarm PS0049)
M30
