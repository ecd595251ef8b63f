O1 (PS0310: no program of this name)
M98 <NOWHERE> (expect alarm PS0310)
M30
