(run with: --param 6050=12)
O1 (section 6.4: O9010 does not exist)
G12 X7. (expect alarm PS0076)
M30
