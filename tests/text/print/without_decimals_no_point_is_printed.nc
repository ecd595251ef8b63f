O1 (OUT-3: format 30)
#1=12.7
DPRNT[N#1[30]X]
M30
(finally prints N13X)
