(run with: --param 6030=70)
O1(M198: parameter 6030 names the code of the external call, and M198 is one like others)
M198
M30
(finally records: mcode 198)
