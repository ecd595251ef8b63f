O1 (PS0231: N names the parameter, R is missing)
G10 L50
N6050 P1 (expect alarm PS0231)
G11
M30
