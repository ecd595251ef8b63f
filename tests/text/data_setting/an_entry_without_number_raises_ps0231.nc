O1 (PS0231: the number of an earlier block does not count)
N6050
G10 L50
R12 (expect alarm PS0231)
G11
M30
