(run with: --param MCA=1)
O1 (MCA: with 1 the number itself is shown)
#3000=5(NO PROBE) (expect alarm MC0005 says NO PROBE)
M30
