O1 (G51: k is not 0)
G51 X0 Y0 P0 (expect alarm PS0142)
M30
