O1 (TRF-2: cancel with G69 first)
G68 X0 Y0 R90.
G91 G28 Z0 (expect alarm PS0049 at G28)
M30
