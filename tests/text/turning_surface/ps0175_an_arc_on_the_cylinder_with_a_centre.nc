(run with: --machine lathe3c)
O1 (PS0175)
G98G00X60.Z2.C0
G07.1C30.
G02Z-10.C30.I3.F100 (expect alarm PS0175)
M30
