O1 (OUT-2: the variable may be computed)
#1=102
#102=7
DPRNT[V#[#1][20]]
M30
(finally prints V7)
