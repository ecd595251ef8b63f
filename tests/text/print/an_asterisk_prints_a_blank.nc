O1 (OUT-2: blanks of the source are dropped)
DPRNT[MEASURED**DIA]
DPRNT[A B  C*D]
M30
(finally prints MEASURED  DIA)
(finally prints ABC D)
