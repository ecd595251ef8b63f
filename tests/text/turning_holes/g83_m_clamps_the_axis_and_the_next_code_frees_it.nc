(run with: --machine lathe3c)
O1 (Holes)
G98
G00X60.Z20.C0
G83C30.Z-4.R-18.F100M31
G80
M30
(finally records: mcode 31; mcode 32)
