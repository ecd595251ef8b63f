O1 (TRF-2: cancel with G50 first)
G51 X0 Y0 P2000
G91 G28 Z0 (expect alarm PS0300 at G28)
M30
