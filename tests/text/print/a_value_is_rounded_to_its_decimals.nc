O1 (OUT-3: all decimals are printed)
#1=2.7183
DPRNT[A#1[12]B#1[14]C#1[11]]
M30
(finally prints A2.72B2.7183C2.7)
