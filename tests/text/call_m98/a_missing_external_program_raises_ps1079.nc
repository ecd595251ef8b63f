O1 (M198-1: the external folder has no O7777)
M198 P7777 (expect alarm PS1079)
M30
