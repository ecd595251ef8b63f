O1 (OUT-1: DPRNT alone is accepted)
DPRNT[START]
M30
(finally prints START)
