O1 (PS0142: a factor of 0)
G51 X0 Y0 P0 (expect alarm PS0142)
M30
