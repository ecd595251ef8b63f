O1 (OUT-1: between POPEN and PCLOS)
POPEN
DPRNT[START]
DPRNT[END]
PCLOS
M30
(finally prints START)
(finally prints END)
