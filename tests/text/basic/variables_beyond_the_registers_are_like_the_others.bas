' more variables than there are registers
v0=0
v1=1
v2=2
v3=3
v4=4
v5=5
v6=6
v7=7
v8=8
v9=9
v10=10
v11=11
v12=12
v13=13
v14=14
v15=15
v16=16
v17=17
v18=18
v19=19
v20=20
v21=21
v22=22
v23=23
v24=24
v25=25
v26=26
v27=27
v28=28
v29=29
v30=30
v31=31
v32=32
v33=33
v34=34
v35=35
v36=36
v37=37
v38=38
v39=39
v40=40
v41=41
v42=42
v43=43
v44=44
v45=45
v46=46
v47=47
v48=48
v49=49
v50=50
v51=51
v52=52
v53=53
v54=54
v55=55
v56=56
v57=57
v58=58
v59=59
v60=60
v61=61
v62=62
v63=63
v64=64
v65=65
v66=66
v67=67
v68=68
v69=69
v70=70
v71=71
v72=72
v73=73
v74=74
v75=75
v76=76
v77=77
v78=78
v79=79
v80=80
v81=81
v82=82
v83=83
v84=84
v85=85
v86=86
v87=87
v88=88
v89=89
s=0
for i=1 to 3
for v85=1 to 2
s=s+v85*v89
next v85
next i
print v0;v79;v80;v85;v89;s;zz ' (expect s=801) (expect warning LW0001 at zz)
print zz
gosub sub
print v88;v3
end
sub: local v88,v3
v88=1000;v3=7
input v87
print v88+v87;v3
return
' (with input: 5)
' (finally v89=89, zz=0, v87=5)
' (finally prints 0 79 80 3 89 801 0)
' (finally prints 0)
' (finally prints ? 1005 7)
' (finally prints 88 3)
