x	=	 1+  	2
   print	x;x
  move ( 1 ,	2 ) ' (expect moves: rapid X1 Y2)
' (finally prints 3 3)
